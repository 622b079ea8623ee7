// SPDX-License-Identifier: LGPL-2.1-or-later

// Tables of a user: the same four numbers in every form that is taken, against
// their values in SI units by hand; what TableWriter writes, to the last digit;
// and what is refused, with the line.

#include <tribody/base/exceptions.h>
#include <tribody/base/table_writer.h>
#include <tribody/tables/csv_table.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>

using namespace Tribody;

void
write(const std::string &text)
{
  std::ofstream("table.csv", std::ios::binary) << text;
}

// Forces of 1250 N and -1.5 N at 0 s and 0.25 s.
void
check(const std::string &what, const std::string &text)
{
  write(text);
  const CsvTable        table("table.csv");
  const Eigen::VectorXd time  = table.column("time", "s"),
                        force = table.column("force x", "N");
  const bool is_right         = table.n_rows() == 2 && time[0] == 0. &&
                        time[1] == 0.25 && force[0] == 1250. &&
                        force[1] == -1.5;
  std::cout << what << ": " << (is_right ? "right" : "WRONG")
            << ", last row at " << table.location(1) << std::endl;
}

void
refuse_file(const std::string &name)
{
  try
    {
      const CsvTable table(name);
      std::cout << "ACCEPTED" << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}

void
refuse(const std::string &text)
{
  write(text);
  refuse_file("table.csv");
}

void
refuse_column(const std::string &text, const std::string &name = "force")
{
  write(text);
  const CsvTable table("table.csv");
  try
    {
      table.column(name, "N", "kN");
      std::cout << "ACCEPTED" << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}

int
main()
{
  const std::string rows = "0,1250\n0.25,-1.5\n";
  check("plain", "time [s],force x [N]\n" + rows);
  check("comments and blanks",
        "# by hand\n\n  time [s] ,  force x[N]\n # more\n 0 , +1250\n\n"
        "2.5e-1 , -1.5e0\n\n");
  check("other units", "time [ms],force x [kN]\n0,1.25\n250,-0.0015\n");
  check("semicolons", "time [s];force x [N]\n0;1250\n0.25;-1.5\n");
  check("tabs", "time [s]\tforce x [N]\n0\t1250\n0.25\t-1.5\n");
  check("commas and tabs", "time [s],\tforce x [N]\n0,\t1250\n0.25,\t-1.5");
  check("another column with words",
        "time [s],note,force x [N]\n0,begin,1250\n0.25,\"end, last\",-1.5\n");
  check("an empty column behind tabs",
        "time [s]\tforce x [N]\tnote\n0\t1250\t\n0.25\t-1.5\t\n");
  check("quotes", "\"time [s]\",\"force x [N]\"\n\"0\",1250\n0.25,\"-1.5\"\n");
  check("DOS", "\xEF\xBB\xBFtime [s],force x [N]\r\n0,1250\r\n0.25,-1.5\r\n");

  // Of other dimensions: by definition.
  write(
    "angle [deg],share [%],state [-],room [degC],tiny [N]\n"
    "180,20,2,20,1e-400\n");
  const CsvTable units("table.csv");
  std::cout << "in SI units: " << units.column("angle", "rad")[0] - M_PI << ' '
            << units.column("share", "")[0] << ' '
            << units.column("state", "")[0] << ' '
            << units.column("room", "K")[0] << ' '
            << units.column("tiny", "N")[0] << std::endl;

  // What the program writes, with the extremes of its numbers.
  TableWriter           writer("written.csv",
                     {"First line.", "time, force: in SI units."},
                     {"time [s]", "moment [N m]", "state [-]"});
  const Eigen::Vector3d first(1. / 3., -1.23456789012345678e-300, 1.);
  const Eigen::Vector3d second(2. / 3., std::numeric_limits<double>::max(), 2.);
  for (const auto &row : {first, second})
    writer.write_row({row[0], row[1], row[2]});
  writer.finish();
  const CsvTable        written("written.csv");
  const Eigen::VectorXd time   = written.column("time", "s"),
                        moment = written.column("moment", "N m"),
                        state  = written.column("state", "");
  for (const auto &[row, i] : {std::make_pair(first, 0), {second, 1}})
    std::cout << "row " << i << " as written: "
              << (row == Eigen::Vector3d(time[i], moment[i], state[i])
                    ? "right"
                    : "WRONG")
              << std::endl;

  refuse_file("no_such_file.csv");
  refuse_file(".");
  refuse_file("/dev/null");
  std::ofstream("long.csv") << "a [N]\n" << std::string(65 << 20, '1');
  refuse_file("long.csv");
  std::ofstream("long.csv");

  refuse("");
  refuse("# only words\n\n");
  refuse(std::string("PK\x03\x04\0\0", 6));
  refuse("0,1\n1,2\n");
  refuse("time [s],\n0,1\n");
  refuse("time [s],[N]\n0,1\n");
  refuse("force [N],force [kN]\n0,1\n");
  refuse("time [s],force [N]\n");
  refuse("time [s],force [N]\n0,1\n1\n");
  refuse("# Decimal commas.\ntime [s],force [N]\n0,1\n\n0,25,1\n");
  refuse("time [s];force [N]\n0;1;2\n");

  refuse_column("time [s],force [N]\n0,1\n", "forse");
  refuse_column("time [s],force [N]\n0,1\n", "Force");
  refuse_column("time [s],force [N]\n0,1\n", "pressure");
  refuse_column("time [s],force\n0,1\n");
  refuse_column("time [s],force []\n0,1\n");
  refuse_column("time [s],force [-]\n0,1\n");
  refuse_column("time [s],force [kg]\n0,1\n");
  refuse_column("time [s],force [1/N]\n0,1\n");
  refuse_column("time [s],force [Newtons of sorts]\n0,1\n");
  refuse_column("time [s],force [2 N]\n0,1\n");
  refuse_column("time [s],force [N]\n0,1\n1,\n");
  refuse_column("time [s];force [N]\n0;1\n1;2,5\n");
  for (const char *text :
       {"", "one", "1 N", "0x10", "1e999", "inf", "-nan", "--1", "1.2.3"})
    refuse_column(std::string("time [s],force [kN]\n0,") + text + "\n");
  refuse_column("time [s],force [kN]\n0,1e307\n");

  write("time [s],state [N]\n0,1\n");
  try
    {
      CsvTable("table.csv").column("state", "");
      std::cout << "ACCEPTED" << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}
