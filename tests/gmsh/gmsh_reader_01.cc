// SPDX-License-Identifier: LGPL-2.1-or-later

// A square of 2 by 1 cells in Gmsh's formats 2 and 4.1, and files that are
// none. Known from how they are made: 6 nodes that cells have, of 7, 2 cells,
// and of the 3 lines one in the group 5 and one in 5 and 6; a minus tells that
// it is the curve the other way round. What is wrong stands beside it.

#include <sys/stat.h>

#include <tribody/base/exceptions.h>
#include <tribody/gmsh/gmsh_reader.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace Tribody;

const std::string head_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string nodes_2 =
  "$Nodes\n7\n10 0 0 0\n1 1 0 0\n2 2 0 0\n3 0 1 0\n4 1 1 0\n5 +2 1e0 0\n"
  "6 9 9 9\n$EndNodes\n";
const std::string elements_2 =
  "$Elements\n6\n1 15 2 1 1 6\n2 1 2 5 1 10 1\n3 1 2 5 1 1 2\n4 1 2 6 1 1 2\n"
  "5 3 2 9 1 10 1 4 3\n6 3 0 1 2 5 4\n$EndElements\n";

const std::string file_4 =
  "$MeshFormat\r\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"bore\"\n"
  "$EndPhysicalNames\n$Entities\n1 2 1 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 5 2 1 -1\n"
  "2 1 0 0 2 0 0 2 -5 6 0\n1 0 0 0 2 1 0 0 0\n$EndEntities\n"
  "$Nodes\n2 7 1 10\n1 1 1 3\n10\n1\n2\n0 0 0 0\n1 0 0 1\n2 0 0 2\n"
  "2 1 0 4\n3\n4\n5\n6\n0 1 0\n1 1 0\n2 1 0\n9 9 9\n$EndNodes\n"
  "$Elements\n3 4 1 4\n1 1 1 1\n1 10 1\n1 2 1 1\n2 1 2\n2 1 3 2\n"
  "3 10 1 4 3\n4 1 2 5 4\n$EndElements\n$Other\n1 2 3\n$EndOther\n";

void
look_at(const std::string &what, const std::string &content)
{
  std::ofstream("a.msh") << content;
  std::cout << what << ": ";
  try
    {
      const Gmsh::PlaneMesh mesh = Gmsh::read_gmsh("a.msh", 1., "File");
      std::cout << mesh.nodes.size() << " nodes, " << mesh.cells.size()
                << " cells, lines";
      for (const auto &line : mesh.lines)
        std::cout << ' ' << mesh.nodes[line.nodes[0]][0] << '-'
                  << mesh.nodes[line.nodes[1]][0] << " (" << line.id << ')';
      std::cout << std::endl;
    }
  catch (const ExcParameter &exception)
    {
      exception.print_info(std::cout);
    }
}

std::string
replaced(std::string text, const std::string &old, const std::string &by)
{
  return text.replace(text.find(old), old.size(), by);
}

int
main()
{
  const std::string file_2 = head_2 + nodes_2 + elements_2;
  look_at("format 2", file_2);
  look_at("format 4.1", file_4);

  look_at("empty", "");
  look_at("format 4.0", replaced(file_4, "4.1", "4"));
  look_at("binary", replaced(file_2, "2.2 0", "2.2 1"));
  look_at("four billion nodes", replaced(file_2, "7\n10", "4294967297\n10"));
  look_at("less than no nodes", replaced(file_2, "7\n10", "-1\n10"));
  look_at("one node more", replaced(file_2, "7\n10", "8\n10"));
  look_at("infinite", replaced(file_2, "2 2 0 0", "2 inf 0 0"));
  look_at("comma", replaced(file_2, "2 2 0 0", "2 2,0 0 0"));
  look_at("too large", replaced(file_2, "2 2 0 0", "2 1e999 0 0"));
  look_at("a node twice", replaced(file_2, "2 2 0 0", "1 2 0 0"));
  look_at("no such node", replaced(file_2, "10 1 4 3", "10 1 4 8"));
  look_at("a triangle", replaced(file_2, "6 3 0 1 2 5 4", "6 2 0 1 2 5"));
  look_at("out of the plane", replaced(file_2, "4 1 1 0", "4 1 1 0.1"));
  look_at("cut", file_2.substr(0, file_2.size() - 20));
  look_at("no end", file_2.substr(0, file_2.size() - 12) + "$End\n");
  look_at("no elements", head_2 + nodes_2);
  look_at("elements first", head_2 + elements_2 + nodes_2);
  look_at("a section without an end", head_2 + "$Comments\nabc\n");

  std::filesystem::remove("a.msh");
  std::filesystem::create_directory("a.msh");
  look_at("a directory", "");
  std::filesystem::remove("a.msh");
  mkfifo("pipe.msh", 0600);
  std::filesystem::create_symlink("pipe.msh", "a.msh");
  try
    {
      Gmsh::read_gmsh("a.msh", 1., "File");
    }
  catch (const ExcParameter &exception)
    {
      std::cout << "a pipe: ";
      exception.print_info(std::cout);
    }
  std::filesystem::remove("a.msh");
  std::filesystem::remove("pipe.msh");
}
