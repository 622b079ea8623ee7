// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_contact_compliance_h
#define tribody_contact_compliance_h

#include <Eigen/Core>

#include <memory>
#include <mutex>

namespace Tribody
{
  class HierarchicalCompliance;

  namespace Contact
  {
    /**
     * How far the nodes of a surface yield to forces along the normals,
     * C [m per N/m], for all contact problems on it. Copies share the matrix,
     * and what one of them prepares of it.
     */
    class Compliance
    {
    public:
      /// @param matrix symmetric and positive definite.
      Compliance(Eigen::MatrixXd matrix = Eigen::MatrixXd());

      /// C [m per N/m], one row and column per node.
      const Eigen::MatrixXd &
      matrix() const
      {
        return content->matrix;
      }

      /// Prepared when it is asked for the first time. Lives as long as any
      /// copy of this object.
      const HierarchicalCompliance &
      hierarchy() const;

    private:
      struct Content
      {
        Eigen::MatrixXd                               matrix;
        std::once_flag                                has_hierarchy;
        std::unique_ptr<const HierarchicalCompliance> hierarchy;

        ~Content();
      };

      std::shared_ptr<Content> content;
    };
  } // namespace Contact
} // namespace Tribody

#endif
