// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef tribody_multibody_cycle_contact_interval_h
#define tribody_multibody_cycle_contact_interval_h

#include <vector>

namespace Tribody
{
  namespace Multibody
  {
    struct ContactEvent;

    /// What a pin does in its bushing.
    enum class ContactState
    {
      /// No contact.
      free = 0,
      /// A contact shorter than the interval between samples.
      impact = 1,
      /// Lasting contact.
      following = 2
    };

    /// One contact of a joint, from its onset to its loss.
    struct ContactInterval
    {
      /// When it began [s]; the start of the motion if it began in contact.
      double onset;
      /// When it ended [s]; the end of the record if it did not.
      double loss;
      /// Whether the onset was seen; else the motion began in contact.
      bool has_onset;
      /// Whether the loss was seen; else the contact lasts beyond the record.
      bool has_loss;
      /// Penetration rate at the onset [m/s]; zero if that was not seen.
      double approach_speed;
      /// Minus the penetration rate at the loss [m/s]; zero if that was not
      /// seen.
      double separation_speed;
      /// Largest total force [N].
      double peak_force;
      /// Impact or following, by its length.
      ContactState state;
    };

    /// What contacts of one joint are listed for.
    struct ContactWindow
    {
      /// Start of the recorded time [s].
      double begin;
      /// End of the recorded time [s].
      double end;
      /// Start of the motion [s].
      double motion_begin;
      /// Contacts shorter than this are impacts [s].
      double longest_impact;
      /// Whether there is contact at the end.
      bool in_contact_at_end;
    };

    /**
     * The contacts of clearance joint @p joint that overlap the time of
     * @p window, from the @p events of the whole motion. The peak force of a
     * contact without a loss is left zero: no event tells it.
     */
    std::vector<ContactInterval>
    list_contacts(const std::vector<ContactEvent> &events,
                  const unsigned int               joint,
                  const ContactWindow             &window);
  } // namespace Multibody
} // namespace Tribody

#endif
