// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_bushing_wearing_pin_h
#define tribody_bushing_wearing_pin_h

#include <Eigen/Core>

#include <tribody/surface/bore_surface.h>
#include <tribody/surface/turned_surfaces.h>
#include <tribody/wear/wear_law.h>
#include <tribody/wear/wear_profile.h>

#include <memory>
#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    struct BearingLoads;
  }

  namespace Coupling
  {
    /// How a pin faces the bore in every sample of a cycle. A plain value;
    /// copies share the transfers.
    struct PinFacings
    {
      /// Pin and bore as worn when the transfers were made.
      std::shared_ptr<const TurnedSurfaces> surfaces;
      /// By which the pin is turned against the bushing in every sample [rad].
      Eigen::VectorXd angles;
      /// P of TurnedSurfaces, one per sample; null if there is none.
      std::shared_ptr<const std::vector<TurnedTransfer>> transfers;

      /// Whether there is no pin that wears.
      bool
      empty() const
      {
        return transfers == nullptr;
      }

      /// P of this @p sample. @pre not empty().
      const TurnedTransfer &
      operator[](const Eigen::Index sample) const
      {
        return (*transfers)[sample];
      }
    };

    /**
     * The surface of a pin that wears. It turns in the bushing, so that its
     * profile is kept in its own frame, at as many nodes as the bore has, at
     * equal angles.
     *
     * Which of its points face which of the bore follows the worn bore
     * (TurnedSurfaces), with the lag of a wear step, as the compliance does.
     * Wear does not change how an elastic pin gives way: what it takes from
     * the radius R is small, and the error of the compliance is of the order
     * of h/R.
     */
    class WearingPin
    {
    public:
      /// @param bore unworn. @param radius of the pin [m].
      WearingPin(const BoreSurface   &bore,
                 const double         radius,
                 const Wear::WearLaw &law);

      /// How the pin faces the bore under @p loads: the angle by which it is
      /// turned is the difference of the contact's angles in both frames.
      /// @param similar is taken if it belongs to the same angles.
      PinFacings
      face(const Multibody::BearingLoads &loads,
           const PinFacings              *similar) const;

      /// Let it be worn by @p depth [m] in all, in a bore as worn as @p bore.
      void
      set_depth(const Eigen::VectorXd &depth, const BoreSurface &bore);

      /// Its curve and how deep it is worn, in its own frame.
      const Wear::WearProfile &
      profile() const
      {
        return wear_profile;
      }

      /// The law by which it wears.
      const Wear::WearLaw &
      law() const
      {
        return wear_law;
      }

      /// Angles of its nodes in its own frame [rad].
      const Eigen::VectorXd &
      node_angles() const
      {
        return angles;
      }

    private:
      void
      face_bore(const BoreSurface &bore);

      Wear::WearLaw     wear_law;
      Eigen::VectorXd   angles;
      Wear::WearProfile wear_profile;
      /// Of the bore nodes [m].
      Eigen::Matrix2Xd                      unworn_positions;
      std::shared_ptr<const TurnedSurfaces> surfaces;
    };
  } // namespace Coupling
} // namespace Tribody

#endif
