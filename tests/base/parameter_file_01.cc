// SPDX-License-Identifier: LGPL-2.1-or-later

// ParameterFile: include, continuation, comments, overrides and the place
// where a value stands; and what it says to what it cannot use. Known from the
// syntax of deal.II's ParameterHandler.

#include <deal.II/base/parameter_handler.h>

#include <sys/stat.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/parameter_file.h>
#include <tribody/base/parameters.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace Tribody;

void
write(const std::string &name, const std::string &content)
{
  std::ofstream(name) << content;
}

enum class Word
{
  one,
  two
};

ChoiceNames<Word>
choice_names(const Word)
{
  return {{Word::one, "one"}, {Word::two, "two"}};
}

struct Example
{
  double                                  radius = 1e-3;
  unsigned int                            n      = 3;
  Word                                    choice = Word::one;
  std::map<std::string, dealii::Point<2>> markers;

  void
  declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Body crank");
    Parameters::add_quantity(prm, "Radius", radius, "m", "A radius.", "mm");
    Parameters::add_integer(prm, "Number", n, "A number.", 1, 10);
    Parameters::add_choice(prm, "Choice", choice, "A word.");
    Parameters::add_named_points(prm, "Markers", markers, "m", "Points.");
    prm.leave_subsection();
  }
};

void
read(const std::string &file, const std::vector<std::string> &overrides = {})
{
  try
    {
      const ParameterFile      parameters(file, overrides);
      Example                  example;
      dealii::ParameterHandler prm;
      example.declare(prm);
      parameters.apply(prm, {{"Body", "Bodies"}});
      std::cout << "radius " << example.radius * 1e3 << " mm at "
                << parameters.location("Body crank/Radius") << ", number "
                << example.n << ", " << name_of(example.choice) << ", markers";
      for (const auto &[name, point] : example.markers)
        std::cout << ' ' << name << " (" << point << ")";
      std::cout << std::endl;
    }
  catch (const ExcInput &exception)
    {
      exception.print_info(std::cout);
    }
}

void
body(const std::string &lines)
{
  write("body.prm", "subsection Body crank\n" + lines + "\nend\n");
  read("body.prm");
}

int
main()
{
  for (const char *name : {"pipe", "circle"})
    std::filesystem::remove(name);
  write("included.prm",
        "subsection Body crank\n  set Radius = 2 mm # later\nend\n");
  write("main.prm",
        "# a comment\ninclude included.prm\nsubsection Body   crank\n"
        "set Number = 5\nset Markers = A: 1 m, 2 m; \\\n  B: 0 m, 0 m\n"
        "set Choice = two\nend\n");
  read("main.prm");
  read("main.prm", {"Body crank/Radius=3 mm"});

  body("set Radios = 3 mm");
  body("set Radius = 3");
  body("set Something else = 3");
  body("set Number = 11");
  body("set Number = -1");
  body("set Choice = three");
  body("set\tNumber = 4");
  body("set Markers = A 1 m, 2 m");
  body("set Markers = A: 1 m");
  body("set Markers = A: 1 m, 2 m; A: 0 m, 0 m");
  body("set Radius 3 mm");
  body("Radius = 3 mm");
  body("include nowhere.prm");
  body("subsection Inner");
  body("end");
  write("other.prm", "subsection Body crnk\nset Radius = 1 mm\nend\n");
  read("other.prm");
  write("loop.prm", "include loop.prm\n");
  read("loop.prm");
  read("does_not_exist.prm");
  read(".");
  read("main.prm", {"Body crank/Radius"});
  read("main.prm", {"Body crank/Radius=3 kg"});
  // What a case is not made of: devices and pipes, files of no end or of many
  // others, lines of foreign files, and control characters.
  write("device.prm", "include /dev/zero\n");
  read("device.prm");
  mkfifo("pipe", 0600);
  read("pipe");
  write("memory.prm", "include /proc/self/mem\n");
  read("memory.prm");
  for (unsigned int i = 1; i <= 13; ++i)
    {
      std::string lines;
      for (unsigned int k = 0; k < 5; ++k)
        lines += "include f" + std::to_string(i + 1) + ".prm\n";
      write("f" + std::to_string(i) + ".prm", lines);
    }
  write("f14.prm", "");
  read("f1.prm");
  read(std::string(300, 'x'));
  write("long_name.prm", "include " + std::string(300, 'x') + "\n");
  read("long_name.prm");
  std::filesystem::create_symlink("circle", "circle");
  write("circle.prm", "include circle\n");
  read("circle.prm");
  write("long_line.prm", "set a = " + std::string(2000000, 'x') + "\n");
  read("long_line.prm");
  write("long_lines.prm", std::string(70000000, '\n'));
  read("long_lines.prm");
  std::filesystem::remove("long_lines.prm");
  body("PATH=/usr/bin\x1b[31m" + std::string(100, 'x') + " secret");
  body(std::string("set Choice = a\0b\xff\xc2\x9b\xc3\xa4", 21));
  body("set Radius = " + std::string(100, '1') + "secret");
  read("main.prm", {"Body crank/Choice=two\nset Number = 7"});
  read("main.prm", {"Body crank/Choice=two # secret"});
  read("main.prm", {"Body crank/Choice=two\\"});
  for (const char *text : {"a, b", "a, a", "a b", ""})
    try
      {
        std::cout << split_names(text).size() << " names" << std::endl;
      }
    catch (const ExcInput &exception)
      {
        exception.print_info(std::cout);
      }
}
