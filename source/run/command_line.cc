// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <boost/program_options.hpp>

#include <tribody/base/console.h>
#include <tribody/base/exceptions.h>
#include <tribody/base/in_quotes.h>
#include <tribody/base/interruption.h>
#include <tribody/base/version.h>
#include <tribody/case/case_parameters.h>
#include <tribody/case/memory_estimate.h>
#include <tribody/output/output_directory.h>
#include <tribody/run/command_line.h>
#include <tribody/run/run_cost.h>
#include <tribody/run/wear_simulation.h>

namespace Tribody
{
  namespace Coupling
  {
    namespace po = boost::program_options;

    namespace
    {
      po::options_description
      make_options()
      {
        po::options_description options("Options");
        // clang-format off
        options.add_options()
          ("check", "read, verify, assemble the mechanism, build the meshes; "
                    "measure what the run would take; report; write nothing")
          ("set", po::value<std::vector<std::string>>()->value_name("\"A/B=value\""),
           "override a parameter, repeatable (A/B: subsections, then the name)")
          ("output", po::value<std::string>()->value_name("DIR"),
           "override the output directory")
          ("resume", "continue from a checkpoint (not available yet)")
          ("print-parameters", "print a commented template with every parameter")
          ("version", "print the version")
          ("help", "print this help");
        // clang-format on
        return options;
      }



      po::variables_map
      parse(const std::vector<std::string> &arguments,
            const po::options_description  &visible)
      {
        po::options_description hidden;
        hidden.add_options()("file", po::value<std::vector<std::string>>());
        po::options_description all;
        all.add(visible).add(hidden);
        po::positional_options_description positional;
        positional.add("file", -1);

        po::variables_map options;
        try
          {
            // No abbreviations: a script must not change its meaning when an
            // option is added.
            po::store(po::command_line_parser(arguments)
                        .options(all)
                        .positional(positional)
                        .style(po::command_line_style::default_style &
                               ~po::command_line_style::allow_guessing)
                        .run(),
                      options);
          }
        catch (const po::error &error)
          {
            throw ExcInput(std::string(error.what()) +
                           "; tribody --help lists the options");
          }
        return options;
      }



      // Before it is taken, as that may last.
      void
      tell_memory(const CaseParameters &parameters,
                  const bool            always,
                  Console              &console)
      {
        constexpr double much   = 1e9;
        const double     needed = estimate_memory(parameters);
        if (always || needed > much)
          console.out() << "Memory: about " << describe_memory(needed)
                        << " while the case is set up" << std::endl;
      }
    } // namespace



    int
    run_command_line(const std::vector<std::string> &arguments,
                     Console                        &console,
                     const MPI_Comm                 &communicator)
    {
      const po::options_description visible = make_options();
      const po::variables_map       options = parse(arguments, visible);

      if (options.count("help") > 0)
        {
          console.out() << "Usage: tribody [options] FILE.prm\n"
                        << visible
                        << "Exit status: 0 done, 1 the run failed, 2 bad input "
                           "or usage, 128 + n stopped by signal n"
                        << std::endl;
          return 0;
        }
      if (options.count("version") > 0)
        {
          console.out() << "tribody " << program_version() << " ("
                        << program_revision() << "), " << library_versions()
                        << std::endl;
          return 0;
        }
      if (options.count("print-parameters") > 0)
        {
          console.out() << parameter_template();
          return 0;
        }
      AssertThrow(options.count("resume") == 0,
                  ExcInput("--resume is not available yet: this version writes "
                           "no checkpoints. Nothing was changed."));
      AssertThrow(options.count("file") > 0 &&
                    options["file"].as<std::vector<std::string>>().size() == 1,
                  ExcInput("Exactly one parameter file is needed: tribody "
                           "[options] FILE.prm; tribody --help lists the "
                           "options"));

      std::vector<std::string> overrides;
      if (options.count("set") > 0)
        overrides = options["set"].as<std::vector<std::string>>();
      CaseParameters parameters =
        read_case(options["file"].as<std::vector<std::string>>().front(),
                  overrides);
      if (options.count("output") > 0)
        parameters.output_directory = options["output"].as<std::string>();

      Output::OutputDirectory directory(parameters.output_directory,
                                        communicator);
      const bool              only_checks = options.count("check") > 0;
      if (!only_checks)
        {
          watch_for_interruption(
            dealii::Utilities::MPI::this_mpi_process(communicator) == 0);
          directory.take();
        }
      console.out() << printable(parameters.title) << std::endl;
      tell_memory(parameters, only_checks, console);
      WearSimulation simulation(parameters, console, communicator);
      simulation.print_setup();
      if (only_checks)
        {
          print_cost(console.out(),
                     measure_cost(simulation,
                                  parameters,
                                  std::chrono::seconds(10),
                                  communicator),
                     parameters);
          console.out() << "The file is in order; nothing was written."
                        << std::endl;
        }
      else
        simulation.run(directory);
      return 0;
    }
  } // namespace Coupling
} // namespace Tribody
