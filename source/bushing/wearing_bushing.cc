// SPDX-License-Identifier: LGPL-2.1-or-later

#include <deal.II/base/mpi.h>

#include <tribody/base/exceptions.h>
#include <tribody/base/ranks.h>
#include <tribody/bushing/elastic_support.h>
#include <tribody/bushing/wearing_bushing.h>
#include <tribody/contact/contact_solver.h>
#include <tribody/contact/force_sensitivity.h>
#include <tribody/multibody/joints/bearing_loads.h>
#include <tribody/wear/constant_extrapolation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace Tribody
{
  namespace Coupling
  {
    namespace
    {
      Wear::WearProfile
      make_profile(const BoreNodes &nodes)
      {
        return Wear::make_wear_profile(nodes.positions,
                                       nodes.radial_directions(),
                                       nodes.degree);
      }



      // Samples with the same nodes in contact one after the other.
      std::vector<std::size_t>
      order_by_active_set(const std::vector<Contact::ContactSolution> &samples,
                          const Ranks::Range                          &range)
      {
        std::vector<std::size_t> order(range.end - range.begin);
        std::iota(order.begin(), order.end(), range.begin);
        std::stable_sort(order.begin(),
                         order.end(),
                         [&](const std::size_t a, const std::size_t b) {
                           return samples[a].active_set < samples[b].active_set;
                         });
        return order;
      }
    } // namespace



    WearingBushing::WearingBushing(const BushingParameters          &parameters,
                                   const Multibody::JointParameters &joint,
                                   const double    compliance_update,
                                   const MPI_Comm &communicator)
      : parameters(parameters)
      , joint(joint)
      , communicator(communicator)
      , law(parameters.wear_law())
      , elastic(parameters, joint, compliance_update, communicator)
      , wear_profile(make_profile(elastic.bore_nodes()))
    {
      if (parameters.pin_wear_coefficient > 0.)
        pin = std::make_unique<WearingPin>(elastic.bore(),
                                           joint.pin_radius,
                                           parameters.pin_wear_law());
      if (parameters.heat.is_on())
        heat = std::make_unique<WarmBushing>(parameters,
                                             joint,
                                             elastic,
                                             communicator);
    }



    CycleContact
    WearingBushing::compute_cycle_contact(const Eigen::VectorXd         &depth,
                                          const Multibody::BearingLoads &loads,
                                          const CycleContact *similar,
                                          const double sliding_distance) const
    {
      return compute_contact(
        depth, loads, similar, Nodes::solved, sliding_distance);
    }



    CycleContact
    WearingBushing::compute_held_contact(const Eigen::VectorXd         &depth,
                                         const Multibody::BearingLoads &loads,
                                         const CycleContact            &held,
                                         const double sliding_distance) const
    {
      AssertDimension(held.samples.size(),
                      static_cast<std::size_t>(loads.size()));
      return compute_contact(
        depth, loads, &held, Nodes::held, sliding_distance);
    }



    std::size_t
    WearingBushing::count_wrong_nodes(const CycleContact &contact) const
    {
      const Ranks::Range own =
        Ranks::share(contact.samples.size(), communicator);
      std::size_t n = 0;
      for (Eigen::Index j = own.begin; j < own.end; ++j)
        n += Contact::n_differing_nodes(contact.samples[j]);
      return dealii::Utilities::MPI::sum(n, communicator);
    }



    CycleContact
    WearingBushing::face_surfaces(const Eigen::VectorXd         &depth,
                                  const Multibody::BearingLoads &loads,
                                  const CycleContact            *similar,
                                  const double sliding_distance) const
    {
      const Wear::WearProfile worn = profile_for_depth(depth);

      CycleContact contact;
      contact.surface         = worn.surface();
      contact.area_derivative = Eigen::VectorXd(depth.size());
      contact.area_derivative.head(worn.depth.size()) =
        worn.area_derivative(contact.surface);
      contact.removed_area  = Eigen::VectorXd::Zero(depth.size());
      contact.peak_pressure = Eigen::VectorXd::Zero(worn.depth.size());
      if (pin)
        {
          contact.facings =
            pin->face(loads, similar == nullptr ? nullptr : &similar->facings);
          Wear::WearProfile worn_pin = pin->profile();
          worn_pin.depth             = surfaces().back().part_of(depth);
          contact.area_derivative.tail(worn_pin.depth.size()) =
            worn_pin.area_derivative(worn_pin.surface());
        }
      if (heat != nullptr)
        contact.force_over_sliding = Eigen::VectorXd::Zero(worn.depth.size());
      contact.samples.resize(loads.size());
      double temperature = Wear::Sliding().temperature;
      if (heat != nullptr)
        temperature = warm.is_known() ? warm.contact_temperature
                                      : parameters.heat.reference_temperature;
      for (Eigen::Index j = 0; j < loads.size(); ++j)
        contact.slidings.push_back(
          {loads.sliding_increment[j],
           loads.sliding_speed.size() > 0 ? loads.sliding_speed[j] : 0.,
           sliding_distance,
           loads.wear_factor.size() > 0 ? loads.wear_factor[j] : 1.,
           temperature});
      return contact;
    }



    CycleContact
    WearingBushing::compute_contact(const Eigen::VectorXd         &depth,
                                    const Multibody::BearingLoads &loads,
                                    const CycleContact            *similar,
                                    const Nodes                    nodes,
                                    const double sliding_distance) const
    {
      CycleContact contact =
        face_surfaces(depth, loads, similar, sliding_distance);
      Eigen::VectorXd pin_depth;
      if (pin)
        pin_depth = surfaces().back().part_of(depth);

      Contact::ContactSolver solver(contact.surface,
                                    elastic.compliance(),
                                    joint.pin_radius,
                                    parameters.contact_solver,
                                    elastic.housing());
      // A bore that comes nearer is a pin that comes nearer.
      const Eigen::VectorXd opening =
        Eigen::VectorXd::Constant(contact.surface.n_nodes(), -warm.closing);
      if (warm.is_known())
        solver.set_pin_recess(opening);

      // Loads mostly follow from the two before with few nodes to change; the
      // same load on a similar bore differs less. But a cycle before may have
      // had fewer. Each rank begins its own sequence.
      const Eigen::Index n_samples = loads.size();
      const bool         has_similar_samples =
        similar != nullptr &&
        static_cast<Eigen::Index>(similar->samples.size()) == n_samples;
      const Ranks::Range own = Ranks::share(n_samples, communicator);
      Ranks::run_together(communicator, [&]() {
        for (Eigen::Index j = own.begin; j < own.end; ++j)
          {
            std::optional<Contact::ContactSolution> start;
            if (has_similar_samples)
              start = similar->samples[j];
            else if (j > own.begin)
              start = Contact::extrapolate(
                contact.samples[std::max(j - 2, own.begin)],
                contact.samples[j - 1]);
            if (pin)
              solver.set_pin_recess(contact.facings[j].to_bore(pin_depth) +
                                    opening);
            Contact::ContactSolution &solution = contact.samples[j];
            const Eigen::Vector2d     force    = force_per_length(loads, j);
            solution =
              nodes == Nodes::held
                ? solver.solve_held(force, start.value())
                : solver.solve_force_controlled(force,
                                                start ? &*start : nullptr);
            AssertThrow(nodes == Nodes::held || solution.report.converged,
                        ExcRun(unsolved_contact(loads, j, solution.report)));

            add_wear(contact, j);
            contact.peak_pressure =
              contact.peak_pressure.cwiseMax(solution.pressure);
            contact.max_pressure =
              std::max(contact.max_pressure,
                       Contact::peak_pressure(solution, contact.surface));
          }
      });

      loads.normal_force.maxCoeff(&contact.peak_sample);
      Ranks::sum(contact.removed_area, communicator);
      if (heat != nullptr)
        Ranks::sum(contact.force_over_sliding, communicator);
      Ranks::max(contact.peak_pressure, communicator);
      contact.max_pressure =
        dealii::Utilities::MPI::max(contact.max_pressure, communicator);
      Contact::broadcast(contact.samples[contact.peak_sample],
                         Ranks::owner(contact.peak_sample,
                                      n_samples,
                                      communicator),
                         communicator);
      contact.wear_rate =
        contact.removed_area.cwiseQuotient(contact.area_derivative);
      return contact;
    }



    void
    WearingBushing::add_wear(CycleContact &contact, const Eigen::Index j) const
    {
      const Eigen::VectorXd &forces  = contact.samples[j].nodal_force;
      const Eigen::VectorXd &weights = contact.surface.weights;
      const Wear::Sliding   &sliding = contact.slidings[j];
      contact.removed_area.head(forces.size()) +=
        law.area_increments(forces, weights, sliding);
      if (pin)
        contact.removed_area.tail(pin->profile().depth.size()) +=
          contact.facings[j].to_pin(
            pin->law().area_increments(forces, weights, sliding));
      if (heat != nullptr)
        contact.force_over_sliding += sliding.increment * forces;
    }



    Eigen::Vector2d
    WearingBushing::force_per_length(const Multibody::BearingLoads &loads,
                                     const Eigen::Index             j) const
    {
      const double angle = loads.contact_angle_bushing[j];
      return loads.normal_force[j] / parameters.axial_length *
             Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }



    std::string
    WearingBushing::unsolved_contact(const Multibody::BearingLoads &loads,
                                     const Eigen::Index             j,
                                     const SolverReport &report) const
    {
      return "Bushing " + name() + ": the contact problem of sample " +
             std::to_string(j) + " of the cycle (normal force " +
             std::to_string(loads.normal_force[j]) +
             " N) has no solution: " + report.message +
             ". A finer mesh (Bore cells) or shorter wear steps (Cycles per "
             "step) may help.";
    }



    Eigen::MatrixXd
    WearingBushing::compute_wear_rate_jacobian(
      const CycleContact &contact) const
    {
      const Eigen::Index        n          = contact.removed_area.size();
      Eigen::MatrixXd           derivative = Eigen::MatrixXd::Zero(n, n);
      Contact::ForceSensitivity sensitivity(contact.surface.positions,
                                            elastic.compliance(),
                                            joint.pin_radius,
                                            elastic.housing()
                                              ? &*elastic.housing()
                                              : nullptr);
      const Ranks::Range        own =
        Ranks::share(contact.samples.size(), communicator);
      for (const std::size_t j : order_by_active_set(contact.samples, own))
        if (!contact.samples[j].active_set.empty())
          subtract_wear_derivative(derivative,
                                   contact,
                                   j,
                                   sensitivity.compute(contact.samples[j]));
      Ranks::sum(derivative, communicator);
      return contact.area_derivative.cwiseInverse().asDiagonal() * derivative;
    }



    void
    WearingBushing::subtract_wear_derivative(Eigen::MatrixXd       &derivative,
                                             const CycleContact    &contact,
                                             const Eigen::Index     j,
                                             const Eigen::MatrixXd &S) const
    {
      const Contact::ContactSolution &sample = contact.samples[j];
      const auto                     &active = sample.active_set;
      const Eigen::Index              n      = sample.nodal_force.size();

      const auto by_force = [&](const Wear::WearLaw &wear_law) {
        return Eigen::VectorXd(
          wear_law.area_derivatives(sample.nodal_force,
                                    contact.surface.weights,
                                    contact.slidings[j])(active));
      };
      const Eigen::VectorXd k_bushing = by_force(law);
      derivative(active, active) -= k_bushing.asDiagonal() * S;
      if (!pin)
        return;

      const Eigen::VectorXd             k_pin = by_force(pin->law());
      const Eigen::SparseMatrix<double> P = contact.facings[j].columns(active);
      const Eigen::SparseMatrix<double> P_k     = P * k_pin.asDiagonal();
      const Eigen::MatrixXd             P_S     = P * S;
      const Eigen::MatrixXd             P_k_S   = P_k * S;
      const Eigen::Index                n_pin   = P.rows();
      const Eigen::MatrixXd             P_k_S_P = P_k_S * P.transpose();
      derivative(active, Eigen::seqN(n, n_pin)) -=
        k_bushing.asDiagonal() * P_S.transpose();
      derivative(Eigen::seqN(n, n_pin), active) -= P_k_S;
      derivative.bottomRightCorner(n_pin, n_pin) -= P_k_S_P;
    }



    std::vector<WearingSurface>
    WearingBushing::surfaces() const
    {
      const Eigen::Index          n = wear_profile.depth.size();
      std::vector<WearingSurface> result{
        {"bushing", 0, n, wear_profile, law, joint.bushing_material.density}};
      if (pin)
        result.push_back({"pin",
                          n,
                          pin->profile().depth.size(),
                          pin->profile(),
                          pin->law(),
                          joint.pin_material.density});
      return result;
    }



    Eigen::VectorXd
    WearingBushing::depth() const
    {
      if (!pin)
        return wear_profile.depth;
      Eigen::VectorXd both(wear_profile.depth.size() +
                           pin->profile().depth.size());
      both << wear_profile.depth, pin->profile().depth;
      return both;
    }



    Eigen::VectorXd
    WearingBushing::depth_after_removing(
      const Eigen::VectorXd &removed_area) const
    {
      Eigen::VectorXd result(removed_area.size());
      for (const WearingSurface &surface : surfaces())
        result.segment(surface.first_node, surface.n_nodes) =
          surface.profile.depth_after_removing(surface.part_of(removed_area));
      return result;
    }



    Wear::WearProfile
    WearingBushing::profile_for_depth(const Eigen::VectorXd &depth) const
    {
      Wear::WearProfile worn = wear_profile;
      worn.depth             = surfaces().front().part_of(depth);
      return worn;
    }



    void
    WearingBushing::set_depth(const Eigen::VectorXd &depth)
    {
      const Wear::WearProfile worn = profile_for_depth(depth);
      elastic.update(worn);
      wear_profile = worn;
      if (heat != nullptr)
        heat->follow_geometry();
      if (pin)
        pin->set_depth(surfaces().back().part_of(depth), elastic.bore());
    }



    void
    WearingBushing::restore(const Eigen::VectorXd &depth,
                            const Eigen::VectorXd &depth_at_compliance)
    {
      const Wear::WearProfile worn = profile_for_depth(depth);
      elastic.restore(worn, depth_at_compliance);
      wear_profile = worn;
      if (heat != nullptr)
        heat->follow_geometry();
      if (pin)
        pin->set_depth(surfaces().back().part_of(depth), elastic.bore());
    }



    void
    WearingBushing::set_warmth(const Warmth &warmth)
    {
      warm = warmth;
      if (heat != nullptr)
        elastic.scale_modulus(heat->modulus_factor(warm));
    }



    double
    WearingBushing::youngs_modulus() const
    {
      return joint.bushing_material.youngs_modulus *
             (heat != nullptr ? heat->modulus_factor(warm) : 1.);
    }



    PeriodicProfile
    WearingBushing::clearance_profile() const
    {
      const double unworn = joint.clearance();
      return PeriodicProfile(node_angles(),
                             (wear_profile.depth.array() + unworn).matrix());
    }



    JointClearance
    WearingBushing::clearance() const
    {
      JointClearance surfaces{clearance_profile(), pin_wear_profile()};
      const double   gap = parameters.rim_support.housing_gap;
      if (gap > 0. || warm.is_known())
        {
          const double unworn = joint.clearance() + gap - warm.closing;
          surfaces.bushing =
            PeriodicProfile(node_angles(),
                            (wear_profile.depth.array() + unworn).matrix());
        }
      return surfaces;
    }



    std::shared_ptr<const Multibody::PinSupport>
    WearingBushing::make_support() const
    {
      return std::make_shared<const ElasticSupport>(elastic,
                                                    parameters,
                                                    joint.pin_radius,
                                                    pin_wear_profile(),
                                                    warm.closing);
    }



    PeriodicProfile
    WearingBushing::pin_wear_profile() const
    {
      return pin ? PeriodicProfile(pin->node_angles(), pin->profile().depth)
                 : PeriodicProfile(0.);
    }



    double
    WearingBushing::largest_clearance(const Eigen::VectorXd &depth) const
    {
      double clearance = joint.clearance();
      for (const WearingSurface &surface : surfaces())
        clearance += surface.part_of(depth).maxCoeff();
      return clearance;
    }



    double
    WearingBushing::lost_wall(const Eigen::VectorXd &depth) const
    {
      return surfaces()
        .front()
        .part_of(depth)
        .cwiseQuotient(elastic.walls())
        .maxCoeff();
    }



    double
    WearingBushing::cycles_to_wear_through(const CycleContact &contact) const
    {
      const Eigen::ArrayXd rate = surfaces().front().part_of(contact.wear_rate);
      const Eigen::ArrayXd left = elastic.walls() - wear_profile.depth;
      double               n    = std::numeric_limits<double>::infinity();
      for (Eigen::Index i = 0; i < rate.size(); ++i)
        if (rate[i] > 0.)
          n = std::min(n, left[i] / rate[i]);
      return n;
    }



    std::vector<double>
    WearingBushing::volumes_for_depth(const Eigen::VectorXd &depth) const
    {
      std::vector<double> volumes;
      for (const WearingSurface &surface : surfaces())
        {
          Wear::WearProfile profile = surface.profile;
          profile.depth             = surface.part_of(depth);
          volumes.push_back(profile.lost_area() * parameters.axial_length);
        }
      return volumes;
    }



    double
    WearingBushing::worn_volume() const
    {
      return elastic.removed_area() * parameters.axial_length;
    }



    double
    WearingBushing::pin_worn_volume() const
    {
      return pin ? pin->profile().lost_area() * parameters.axial_length : 0.;
    }



    double
    WearingBushing::max_stable_step(const CycleContact &contact) const
    {
      // The largest derivative of what a node loses with respect to its force,
      // summed over the samples: k times the sliding distance for Archard.
      double wear_per_pressure = 0.;
      for (const WearingSurface &surface : surfaces())
        {
          Eigen::VectorXd sum =
            Eigen::VectorXd::Zero(contact.surface.n_nodes());
          double constant = 0.;
          if (surface.law.is_constant())
            for (const Wear::Sliding &sliding : contact.slidings)
              constant += surface.law.archard.area_increment(1.,
                                                             sliding.increment *
                                                               sliding.factor);
          else
            {
              const Ranks::Range own =
                Ranks::share(contact.samples.size(), communicator);
              for (Eigen::Index j = own.begin; j < own.end; ++j)
                sum +=
                  surface.law.area_derivatives(contact.samples[j].nodal_force,
                                               contact.surface.weights,
                                               contact.slidings[j]);
              Ranks::sum(sum, communicator);
            }
          wear_per_pressure += constant + sum.maxCoeff();
        }
      // Nothing wears, nothing can become unstable.
      if (!(wear_per_pressure > 0.))
        return std::numeric_limits<double>::max();
      return Wear::max_stable_step(elastic.stiffest_compliance(),
                                   wear_profile.area_derivative(elastic.bore()),
                                   wear_per_pressure);
    }



    void
    WearingBushing::write_vtu(const std::string  &file_name,
                              const CycleContact &contact) const
    {
      Output::TemperatureField temperature;
      if (warm.is_known())
        temperature = {&heat->get_dof_handler(), &warm.temperature};
      elastic.write_vtu(file_name, contact.at_peak_force(), temperature);
    }
  } // namespace Coupling
} // namespace Tribody
