// SPDX-License-Identifier: LGPL-2.1-or-later

#include <Eigen/LU>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <tribody/base/exceptions.h>
#include <tribody/sundials/ida_linear_solver.h>
#include <tribody/sundials/ida_vector.h>

#include <algorithm>
#include <vector>

namespace Tribody
{
  namespace Sundials
  {
    namespace
    {
      // Systems of more unknowns than this are sparse; see
      // doc/decisions.md, "Linear solver of the dynamics".
      constexpr Eigen::Index largest_dense_size = 48;



      // SUNDIALS' own dense solver takes ten times as long to substitute.
      class DenseSolver : public IdaLinearSolver
      {
      public:
        DenseSolver(const Eigen::Index size, SUNContext context);

        bool
        assemble(const Assembler &assembler) override;

      private:
        Eigen::Map<Eigen::MatrixXd>
        entries_of(SUNMatrix dense) const
        {
          return {SUNDenseMatrix_Data(dense),
                  SUNDenseMatrix_Rows(dense),
                  SUNDenseMatrix_Columns(dense)};
        }

        static int
        factorise(SUNLinearSolver solver, SUNMatrix matrix);

        static int
        substitute(SUNLinearSolver solver,
                   SUNMatrix /*matrix*/,
                   N_Vector x,
                   N_Vector b,
                   realtype /*tolerance*/);

        Eigen::PartialPivLU<Eigen::MatrixXd> lu;
      };



      DenseSolver::DenseSolver(const Eigen::Index size, SUNContext context)
        : lu(size)
      {
        matrix = SUNDenseMatrix(size, size, context);
        solver = SUNLinSolNewEmpty(context);
        if (solver == nullptr)
          return;
        solver->content      = this;
        solver->ops->gettype = [](SUNLinearSolver) {
          return SUNLINEARSOLVER_DIRECT;
        };
        solver->ops->getid = [](SUNLinearSolver) {
          return SUNLINEARSOLVER_CUSTOM;
        };
        solver->ops->setup = factorise;
        solver->ops->solve = substitute;
        solver->ops->free  = [](SUNLinearSolver itself) {
          itself->content = nullptr; // this object is not SUNDIALS' to free
          SUNLinSolFreeEmpty(itself);
          return 0;
        };
      }



      bool
      DenseSolver::assemble(const Assembler &assembler)
      {
        Eigen::Map<Eigen::MatrixXd> dense = entries_of(matrix);
        dense.setZero();
        DenseEntries entries(dense);
        assembler(entries);
        return dense.allFinite();
      }



      int
      DenseSolver::factorise(SUNLinearSolver solver, SUNMatrix matrix)
      {
        auto &self = *static_cast<DenseSolver *>(solver->content);
        self.lu.compute(self.entries_of(matrix));
        // A positive value lets IDA try a shorter step.
        return (self.lu.matrixLU().diagonal().array() == 0.).any() ? 1 : 0;
      }



      int
      DenseSolver::substitute(SUNLinearSolver solver,
                              SUNMatrix,
                              N_Vector x,
                              N_Vector b,
                              realtype)
      {
        auto &self = *static_cast<DenseSolver *>(solver->content);
        view(x)    = self.lu.solve(view(b));
        return 0;
      }



      class SparseSolver : public IdaLinearSolver
      {
      public:
        SparseSolver(const Eigen::Index size,
                     const Assembler   &assembler,
                     SUNContext         context);

        bool
        assemble(const Assembler &assembler) override;

      private:
        // Collects where entries are.
        struct Pattern : public MatrixEntries
        {
          void
          add(const Eigen::Index row,
              const Eigen::Index column,
              const double /*value*/) override
          {
            places.emplace_back(column, row);
          }

          std::vector<std::pair<sunindextype, sunindextype>> places;
        };

        struct Entries : public MatrixEntries
        {
          Entries(const SparseSolver &pattern, realtype *values)
            : pattern(pattern)
            , values(values)
          {}

          void
          add(const Eigen::Index row,
              const Eigen::Index column,
              const double       value) override
          {
            const auto begin =
              pattern.rows.begin() + pattern.column_starts[column];
            const auto end =
              pattern.rows.begin() + pattern.column_starts[column + 1];
            const auto found = std::lower_bound(begin, end, row);
            Assert(found != end && *found == row,
                   dealii::ExcMessage("An element adds to a place that it had "
                                      "not named."));
            values[found - pattern.rows.begin()] += value;
          }

          const SparseSolver &pattern;
          realtype           *values;
        };

        std::vector<sunindextype> column_starts;
        std::vector<sunindextype> rows;
      };



      SparseSolver::SparseSolver(const Eigen::Index size,
                                 const Assembler   &assembler,
                                 SUNContext         context)
        : column_starts(size + 1, 0)
      {
        Pattern pattern;
        assembler(pattern);
        auto &places = pattern.places;
        std::sort(places.begin(), places.end());
        places.erase(std::unique(places.begin(), places.end()), places.end());
        for (const auto &[column, row] : places)
          {
            ++column_starts[column + 1];
            rows.push_back(row);
          }
        for (Eigen::Index j = 0; j < size; ++j)
          column_starts[j + 1] += column_starts[j];

        matrix = SUNSparseMatrix(size, size, rows.size(), CSC_MAT, context);
        const N_Vector vector = N_VNew_Serial(size, context);
        if (matrix != nullptr && vector != nullptr)
          solver = SUNLinSol_KLU(vector, matrix, context);
        if (vector != nullptr)
          N_VDestroy(vector);
      }



      bool
      SparseSolver::assemble(const Assembler &assembler)
      {
        // IDA has cleared the pattern too.
        std::copy(column_starts.begin(),
                  column_starts.end(),
                  SUNSparseMatrix_IndexPointers(matrix));
        std::copy(rows.begin(),
                  rows.end(),
                  SUNSparseMatrix_IndexValues(matrix));
        Eigen::Map<Eigen::VectorXd> values(SUNSparseMatrix_Data(matrix),
                                           rows.size());
        values.setZero();
        Entries entries(*this, values.data());
        assembler(entries);
        return values.allFinite();
      }
    } // namespace



    IdaLinearSolver::~IdaLinearSolver()
    {
      SUNLinSolFree(solver);
      SUNMatDestroy(matrix);
    }



    std::unique_ptr<IdaLinearSolver>
    IdaLinearSolver::create(const Eigen::Index size,
                            const Assembler   &assembler,
                            SUNContext         context)
    {
      std::unique_ptr<IdaLinearSolver> result;
      if (size <= largest_dense_size)
        result = std::make_unique<DenseSolver>(size, context);
      else
        result = std::make_unique<SparseSolver>(size, assembler, context);
      AssertThrow(result->matrix != nullptr && result->solver != nullptr,
                  ExcRun("SUNDIALS could not allocate its memory."));
      return result;
    }
  } // namespace Sundials
} // namespace Tribody
