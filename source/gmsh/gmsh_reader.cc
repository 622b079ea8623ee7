// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/base/exceptions.h>
#include <tribody/gmsh/gmsh_reader.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <system_error>
#include <unordered_map>

namespace Tribody
{
  namespace Gmsh
  {
    namespace
    {
      /// Of a file [bytes]: some ten million cells.
      constexpr std::uintmax_t largest_file = 1000000000;

      // Gmsh's numbers of the elements that such a mesh may have.
      constexpr long line_type = 1, quadrilateral_type = 3, point_type = 15;

      std::string
      read_text(const std::string &name, const std::string &where)
      {
        std::error_code error;
        const auto      status = std::filesystem::status(name, error);
        AssertThrow(!error ||
                      status.type() == std::filesystem::file_type::not_found,
                    ExcParameter(where,
                                 "the file '" + name +
                                   "' cannot be opened: " + error.message()));
        // Of a pipe or a device nobody knows where it ends.
        AssertThrow(!std::filesystem::exists(status) ||
                      std::filesystem::is_regular_file(status),
                    ExcParameter(where, "'" + name + "' is not a file"));
        std::ifstream stream(name, std::ios::binary);
        const auto    size = std::filesystem::file_size(name, error);
        AssertThrow(stream && !error,
                    ExcParameter(where,
                                 "the file '" + name + "' cannot be opened"));
        AssertThrow(size <= largest_file,
                    ExcParameter(where,
                                 "'" + name + "' is larger than " +
                                   std::to_string(largest_file / 1000000) +
                                   " MB"));
        std::string text(size, ' ');
        stream.read(text.data(), static_cast<std::streamsize>(size));
        AssertThrow(stream,
                    ExcParameter(where,
                                 "the file '" + name + "' cannot be read"));
        return text;
      }



      /// The words of a file, one after the other.
      class Words
      {
      public:
        Words(const std::string &name, const std::string &where)
          : text(read_text(name, where))
          , name(name)
          , where(where)
        {}

        [[noreturn]] void
        fail(const std::string &problem) const
        {
          throw ExcParameter(where,
                             "'" + name + "', line " + std::to_string(line) +
                               ": " + problem);
        }

        /// Empty at the end of the file.
        std::string_view
        next()
        {
          for (; at < text.size() && is_space(text[at]); ++at)
            if (text[at] == '\n')
              ++line;
          const std::size_t begin = at;
          while (at < text.size() && !is_space(text[at]))
            ++at;
          return std::string_view(text).substr(begin, at - begin);
        }

        /// @p Number: long or double.
        template <typename Number>
        Number
        number(const char *meaning)
        {
          std::string_view word = next();
          if (word.empty())
            fail("the file ends where " + std::string(meaning) +
                 " is expected");
          if (word.front() == '+')
            word.remove_prefix(1);
          Number     value  = 0;
          const auto result = std::from_chars(word.begin(), word.end(), value);
          if (result.ec != std::errc() || result.ptr != word.end())
            fail(std::string(meaning) + " is expected");
          return value;
        }

        /// How many of @p meaning follow: no more than the file has bytes.
        std::size_t
        count(const char *meaning)
        {
          const long n = number<long>(meaning);
          if (n < 0 || static_cast<std::size_t>(n) > text.size() - at)
            fail(std::to_string(n) + " is not " + meaning +
                 " that the file can hold");
          return n;
        }

        void
        expect(const std::string &word)
        {
          if (next() != word)
            fail(word + " is expected");
        }

        /// Go on behind the next @p word.
        void
        skip_to(const std::string &word)
        {
          std::string_view found;
          do
            found = next();
          while (!found.empty() && found != word);
          if (found.empty())
            fail("the file ends without " + word);
        }

        void
        skip(const std::size_t n_numbers)
        {
          for (std::size_t i = 0; i < n_numbers; ++i)
            number<double>("a number");
        }

      private:
        static bool
        is_space(const char c)
        {
          return std::isspace(static_cast<unsigned char>(c)) != 0;
        }

        const std::string text;
        const std::string name;
        const std::string where;
        std::size_t       at   = 0;
        std::size_t       line = 1;
      };



      /// What a file holds, one section after the other.
      class GmshReader
      {
      public:
        GmshReader(Words &words, const double length_unit)
          : words(words)
          , length_unit(length_unit)
        {}

        PlaneMesh
        read()
        {
          words.expect("$MeshFormat");
          read_format();
          for (std::string word(words.next()); !word.empty();
               word = words.next())
            {
              if (word.front() != '$')
                words.fail("the name of a section is expected, as $Nodes");
              if (word == "$Entities" && is_format_4)
                read_entities();
              else if (word == "$Nodes")
                read_nodes();
              else if (word == "$Elements")
                read_elements();
              else
                {
                  words.skip_to("$End" + word.substr(1));
                  continue;
                }
              words.expect("$End" + word.substr(1));
            }
          if (mesh.cells.empty())
            words.fail("the file ends and has no quadrilaterals");
          leave_out_unused_nodes();
          return mesh;
        }

      private:
        void
        read_format()
        {
          const double version = words.number<double>("the file's format");
          is_format_4          = version == 4.1;
          if (!is_format_4 && !(version >= 2. && version < 3.))
            words.fail(
              "the file's format is neither 2 nor 4.1; in Gmsh: "
              "'Mesh.MshFileVersion = 2.2'");
          if (words.number<long>("the kind of file") != 0)
            words.fail("the file is binary; in Gmsh: 'Mesh.Binary = 0'");
          words.number<long>("the size of a number");
          words.expect("$EndMeshFormat");
        }



        // What belongs to a physical group is the curve, not its lines.
        void
        read_entities()
        {
          std::array<std::size_t, 4> n{};
          for (std::size_t &n_of_dimension : n)
            n_of_dimension = words.count("a number of entities");
          for (unsigned int dimension = 0; dimension < 4; ++dimension)
            for (std::size_t i = 0; i < n[dimension]; ++i)
              {
                const long tag = words.number<long>("an entity");
                words.skip(dimension == 0 ? 3 : 6);
                std::vector<long> groups(
                  words.count("a number of physical groups"));
                // A minus turns the curve only.
                for (long &group : groups)
                  group = std::abs(words.number<long>("a physical group"));
                if (dimension == 1)
                  groups_of_curve[tag] = groups;
                if (dimension > 0)
                  words.skip(words.count("a number of boundaries"));
              }
        }



        void
        read_nodes()
        {
          if (!mesh.nodes.empty())
            words.fail("a second $Nodes");
          if (!is_format_4)
            {
              const std::size_t n = words.count("a number of nodes");
              for (std::size_t i = 0; i < n; ++i)
                {
                  const long tag = words.number<long>("the number of a node");
                  read_node(tag);
                }
              return;
            }
          const std::size_t n_blocks = words.count("a number of blocks");
          words.skip(3);
          for (std::size_t b = 0; b < n_blocks; ++b)
            {
              const long dimension = words.number<long>("a dimension");
              words.number<long>("an entity");
              const bool has_parameters = words.number<long>("0 or 1") != 0;
              std::vector<long> tags(words.count("a number of nodes"));
              for (long &tag : tags)
                tag = words.number<long>("the number of a node");
              for (const long tag : tags)
                {
                  read_node(tag);
                  if (has_parameters)
                    words.skip(std::clamp(dimension, 0L, 3L));
                }
            }
        }



        void
        read_node(const long tag)
        {
          dealii::Point<2> x;
          for (unsigned int d = 0; d < 2; ++d)
            x[d] = length_unit * words.number<double>("a coordinate");
          const double z = length_unit * words.number<double>("a coordinate");
          if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(z))
            words.fail("a coordinate is not a finite number");
          if (!index_of_node.emplace(tag, mesh.nodes.size()).second)
            words.fail("a second node " + std::to_string(tag));
          mesh.nodes.push_back(x);
          heights.push_back(z);
        }



        void
        read_elements()
        {
          const std::size_t n = words.count(
            is_format_4 ? "a number of blocks" : "a number of elements");
          if (!is_format_4)
            {
              for (std::size_t i = 0; i < n; ++i)
                {
                  words.number<long>("the number of an element");
                  const long        type = words.number<long>("a type");
                  std::vector<long> tags(words.count("a number of tags"));
                  for (long &tag : tags)
                    tag = words.number<long>("a tag");
                  read_element(type, {tags.empty() ? 0 : tags.front()});
                }
              return;
            }
          words.skip(3);
          for (std::size_t b = 0; b < n; ++b)
            {
              words.number<long>("a dimension");
              const long        entity = words.number<long>("an entity");
              const long        type   = words.number<long>("a type");
              const std::size_t n_elements =
                words.count("a number of elements");
              const auto groups = groups_of_curve.find(entity);
              for (std::size_t i = 0; i < n_elements; ++i)
                {
                  words.number<long>("the number of an element");
                  read_element(type,
                               type == line_type &&
                                   groups != groups_of_curve.end()
                                 ? groups->second
                                 : std::vector<long>{0});
                }
            }
        }



        void
        read_element(const long type, const std::vector<long> &groups)
        {
          if (type == quadrilateral_type)
            {
              std::array<unsigned int, 4> cell{};
              for (unsigned int &node : cell)
                node = read_index();
              mesh.cells.push_back(cell);
            }
          else if (type == line_type)
            {
              std::array<unsigned int, 2> nodes{};
              for (unsigned int &node : nodes)
                node = read_index();
              for (const long id : groups)
                mesh.lines.push_back({nodes, id});
            }
          else if (type == point_type)
            read_index();
          else
            words.fail("an element of type " + std::to_string(type) +
                       ": cells that are not quadrilaterals with straight "
                       "edges; let Gmsh recombine its triangles ('Recombine "
                       "Surface') in first order ('Mesh.ElementOrder = 1')");
        }



        unsigned int
        read_index()
        {
          const long tag   = words.number<long>("the number of a node");
          const auto index = index_of_node.find(tag);
          if (index == index_of_node.end())
            words.fail("there is no node " + std::to_string(tag));
          return index->second;
        }



        // Centres of arcs for example; and the others lie in a plane.
        void
        leave_out_unused_nodes()
        {
          constexpr unsigned int        unused = -1;
          std::vector<unsigned int>     new_index(mesh.nodes.size(), unused);
          std::vector<dealii::Point<2>> nodes;
          const double height = heights[mesh.cells.front().front()];
          double       size = 0., rise = 0.;
          for (auto &cell : mesh.cells)
            for (unsigned int &node : cell)
              {
                size = std::max(size, mesh.nodes[node].norm());
                rise = std::max(rise, std::abs(heights[node] - height));
                if (new_index[node] == unused)
                  {
                    new_index[node] = nodes.size();
                    nodes.push_back(mesh.nodes[node]);
                  }
                node = new_index[node];
              }
          if (rise > 1e-6 * size)
            words.fail(
              "the mesh ends and has not the same z everywhere; it "
              "must lie in the x-y plane");
          std::vector<PlaneMesh::Line> lines;
          for (const PlaneMesh::Line &line : mesh.lines)
            if (new_index[line.nodes[0]] != unused &&
                new_index[line.nodes[1]] != unused)
              lines.push_back(
                {{{new_index[line.nodes[0]], new_index[line.nodes[1]]}},
                 line.id});
          mesh.nodes.swap(nodes);
          mesh.lines.swap(lines);
        }

        Words                                 &words;
        const double                           length_unit;
        bool                                   is_format_4 = false;
        PlaneMesh                              mesh;
        std::vector<double>                    heights;
        std::unordered_map<long, unsigned int> index_of_node;
        std::map<long, std::vector<long>>      groups_of_curve;
      };
    } // namespace



    PlaneMesh
    read_gmsh(const std::string &name,
              const double       length_unit,
              const std::string &where)
    {
      Words words(name, where);
      return GmshReader(words, length_unit).read();
    }
  } // namespace Gmsh
} // namespace Tribody
