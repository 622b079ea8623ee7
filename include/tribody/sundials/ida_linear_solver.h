// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_sundials_ida_linear_solver_h
#define tribody_sundials_ida_linear_solver_h

#include <Eigen/Core>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <tribody/algebra/matrix_entries.h>

#include <functional>
#include <memory>

namespace Tribody
{
  namespace Sundials
  {
    /**
     * The direct solver of IDA's linear systems with its matrix: dense (the LU
     * decomposition of Eigen) for small systems, sparse (KLU) for large ones.
     * Owns both; IDA only refers to them.
     */
    class IdaLinearSolver
    {
    public:
      /// Adds all entries of a Jacobian to what it is given.
      using Assembler = std::function<void(MatrixEntries &)>;

      /**
       * @param size number of unknowns.
       * @param assembler at some state: tells where entries are. Called only
       *   for a sparse matrix.
       */
      static std::unique_ptr<IdaLinearSolver>
      create(const Eigen::Index size,
             const Assembler   &assembler,
             SUNContext         context);

      IdaLinearSolver() = default;

      virtual ~IdaLinearSolver();

      IdaLinearSolver(const IdaLinearSolver &) = delete;
      IdaLinearSolver &
      operator=(const IdaLinearSolver &) = delete;

      /// Set the matrix to what @p assembler adds up. Allocates nothing.
      /// @return whether all entries are finite.
      virtual bool
      assemble(const Assembler &assembler) = 0;

      /// For IDA; released with this object.
      SUNMatrix matrix = nullptr;
      /// Factorises and solves with the matrix; released with this object.
      SUNLinearSolver solver = nullptr;
    };
  } // namespace Sundials
} // namespace Tribody

#endif
