// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tests_support_reference_table_h
#define tests_support_reference_table_h

#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// The rows of a CSV file, without comment lines and header. A test that misses
/// its reference must not go on.
inline std::vector<std::vector<double>>
read_reference_table(const std::string &file_name)
{
  std::ifstream                    file(file_name);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);)
    {
      if (line.empty() || std::isdigit(line[0]) == 0)
        continue;
      rows.emplace_back();
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');)
        rows.back().push_back(std::stod(cell));
    }
  if (rows.empty())
    throw std::runtime_error("There are no numbers in " + file_name);
  return rows;
}

#endif
