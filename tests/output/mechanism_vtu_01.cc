// SPDX-License-Identifier: LGPL-2.1-or-later

// The film of a mechanism: what ParaView needs of a file is there. Known from
// the input: a line of three points makes two cells of two points each, a point
// that carries a force one cell.

#include <tribody/output/mechanism_vtu.h>

#include <fstream>
#include <iostream>
#include <sstream>

using namespace Tribody;

int
main()
{
  Output::MechanismLine link;
  link.body   = 1;
  link.points = {{0., 0.}, {1., 0.}, {1., 2.}};
  Output::MechanismLine joint;
  joint.part   = Output::MechanismPart::joint;
  joint.joint  = 0;
  joint.points = {{1., 2.}, {1., 2.}};
  joint.force  = {3., -4.};
  Output::write_mechanism_vtu("mechanism.vtu", {link, joint});

  std::ifstream     file("mechanism.vtu");
  std::stringstream content;
  content << file.rdbuf();
  const std::string text = content.str();
  for (const char *wanted : {"NumberOfPoints=\"6\"",
                             "NumberOfCells=\"3\"",
                             "Name=\"force\" NumberOfComponents=\"3\"",
                             "Name=\"part\"",
                             "Name=\"body\"",
                             "Name=\"joint\""})
    std::cout << wanted << ": " << (text.find(wanted) != std::string::npos)
              << std::endl;
  // Each array has its data on the line after its head; deal.II writes none for
  // cells whose kind it does not know.
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    for (const char *name : {"connectivity", "offsets", "types"})
      if (line.find(std::string("Name=\"") + name) != std::string::npos)
        {
          std::string data;
          std::getline(lines, data);
          std::cout << name << " has data: " << (data.size() > 10) << std::endl;
        }
}
