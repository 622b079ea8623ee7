// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/algebra/hierarchical_compliance.h>
#include <tribody/contact/compliance.h>

#include <utility>

namespace Tribody
{
  namespace Contact
  {
    Compliance::Content::~Content() = default;



    Compliance::Compliance(Eigen::MatrixXd matrix)
      : content(std::make_shared<Content>())
    {
      content->matrix = std::move(matrix);
    }



    const HierarchicalCompliance &
    Compliance::hierarchy() const
    {
      std::call_once(content->has_hierarchy, [this]() {
        content->hierarchy =
          std::make_unique<const HierarchicalCompliance>(content->matrix);
      });
      return *content->hierarchy;
    }
  } // namespace Contact
} // namespace Tribody
