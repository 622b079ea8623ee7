// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/bushing/wearing_pin.h>
#include <tribody/multibody/joints/bearing_loads.h>

namespace Tribody
{
  namespace Coupling
  {
    WearingPin::WearingPin(const BoreSurface   &bore,
                           const double         radius,
                           const Wear::WearLaw &law)
      : wear_law(law)
      , angles(TurnedSurfaces::pin_node_angles(bore.n_nodes() / bore.degree,
                                               bore.degree))
      , wear_profile(Wear::make_pin_profile(radius, angles, bore.degree))
      , unworn_positions(bore.positions)
    {
      face_bore(bore);
    }



    PinFacings
    WearingPin::face(const Multibody::BearingLoads &loads,
                     const PinFacings              *similar) const
    {
      PinFacings facings;
      facings.surfaces = surfaces;
      facings.angles   = loads.contact_angle_bushing - loads.contact_angle_pin;
      // Eigen compares vectors of the same size only.
      if (similar != nullptr && similar->surfaces == surfaces &&
          similar->angles.size() == facings.angles.size() &&
          similar->angles == facings.angles)
        return *similar;

      auto transfers = std::make_shared<std::vector<TurnedTransfer>>();
      for (Eigen::Index j = 0; j < facings.angles.size(); ++j)
        transfers->push_back(surfaces->turned_by(facings.angles[j]));
      facings.transfers = transfers;
      return facings;
    }



    void
    WearingPin::set_depth(const Eigen::VectorXd &depth, const BoreSurface &bore)
    {
      wear_profile.depth = depth;
      face_bore(bore);
    }



    void
    WearingPin::face_bore(const BoreSurface &bore)
    {
      surfaces = std::make_shared<TurnedSurfaces>(bore,
                                                  unworn_positions,
                                                  angles.size() / bore.degree);
    }
  } // namespace Coupling
} // namespace Tribody
