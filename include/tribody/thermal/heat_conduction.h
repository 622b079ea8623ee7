// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_thermal_heat_conduction_h
#define tribody_thermal_heat_conduction_h

#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <Eigen/Core>

#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class Mapping;
} // namespace dealii

namespace Tribody
{
  namespace Thermal
  {
    /// How much warmer a bushing is than its surroundings.
    struct TemperatureRise
    {
      /// Over the degrees of freedom of HeatConduction [K].
      dealii::Vector<double> field;
      /// At the bore nodes [K].
      Eigen::VectorXd at_bore;
      /// Over the cross section [K].
      double mean = 0.;
    };

    /// Of the edge of @p triangulation that is BoundaryIds::rim, as a curve of
    /// the given @p degree [m].
    double
    rim_length(const dealii::Triangulation<2, 2> &triangulation,
               const unsigned int                 degree);

    /**
     * Steady conduction of heat in the cross section of a bushing from its bore
     * to its rim, per length along the axis,
     * @f[ \int_\Omega \lambda \nabla T \cdot \nabla v\,dx
     *     + \int_{rim} \alpha\,T\,v\,ds = \sum_i q_i v(x_i) \quad \forall v
     * @f]
     * with the heat q that friction leaves at the nodes of the bore, or T = 0
     * at a rim that is as cold as the surroundings. Other edges, and the faces
     * of the bushing, are insulated. T is counted from the temperature of the
     * surroundings.
     *
     * Use: construct once per mesh, reinit() per geometry, then solve().
     */
    class HeatConduction
    {
    public:
      /**
       * @param triangulation serial, with BoundaryIds; must outlive this.
       * @param degree of the elements.
       * @param conductivity lambda [W/(m K)], positive.
       * @param heat_transfer_coefficient alpha at the rim [W/(m^2 K)],
       *   positive; infinite: T = 0 there.
       */
      HeatConduction(const dealii::Triangulation<2, 2> &triangulation,
                     const unsigned int                 degree,
                     const double                       conductivity,
                     const double heat_transfer_coefficient);

      /// On the image of the mesh under @p mapping.
      void
      reinit(const dealii::Mapping<2, 2> &mapping);

      /// The temperature. @param nodal_heat q, into each bore node [W/m], in
      ///   the order of BoreNodes.
      TemperatureRise
      solve(const Eigen::VectorXd &nodal_heat) const;

      /// The same temperature everywhere.
      TemperatureRise
      uniform(const double rise) const;

      /// Of the temperatures.
      const dealii::DoFHandler<2, 2> &
      get_dof_handler() const
      {
        return dof_handler;
      }

    private:
      dealii::FE_Q<2>                   fe;
      dealii::DoFHandler<2, 2>          dof_handler;
      double                            conductivity;
      double                            heat_transfer_coefficient;
      dealii::SparsityPattern           sparsity;
      dealii::AffineConstraints<double> constraints;
      /// Degrees of freedom of the bore nodes.
      std::vector<dealii::types::global_dof_index> bore_dofs;
      dealii::SparseMatrix<double>                 matrix;
      /// Its factors; solving changes what it counts.
      mutable dealii::SparseDirectUMFPACK solver;
      /// What makes a mean over the cross section of nodal values [-].
      dealii::Vector<double> averages;
    };
  } // namespace Thermal
} // namespace Tribody

#endif
