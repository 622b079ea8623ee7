// SPDX-License-Identifier: LGPL-2.1-or-later

#include <tribody/multibody/cycle/contact_interval.h>
#include <tribody/multibody/motion/motion_integrator.h>

namespace Tribody
{
  namespace Multibody
  {
    std::vector<ContactInterval>
    list_contacts(const std::vector<ContactEvent> &events,
                  const unsigned int               joint,
                  const ContactWindow             &window)
    {
      std::vector<ContactInterval> contacts;
      // A contact whose loss is still to come. A motion that starts in contact
      // shows it by a loss without an onset, or by no event at all.
      ContactInterval open = {
        window.motion_begin, 0., false, false, 0., 0., 0., {}};
      const auto close = [&](const double time) {
        open.loss = time;
        open.state =
          open.has_loss && open.loss - open.onset < window.longest_impact
            ? ContactState::impact
            : ContactState::following;
        if (open.loss > window.begin && open.onset < window.end)
          contacts.push_back(open);
      };
      for (const ContactEvent &event : events)
        {
          if (event.joint != joint)
            continue;
          if (event.is_onset)
            {
              open = {event.time,
                      0.,
                      true,
                      false,
                      event.penetration_rate,
                      0.,
                      0.,
                      {}};
              continue;
            }
          open.has_loss         = true;
          open.separation_speed = -event.penetration_rate;
          open.peak_force       = event.peak_force;
          close(event.time);
        }
      if (window.in_contact_at_end && !open.has_loss)
        close(window.end);
      return contacts;
    }
  } // namespace Multibody
} // namespace Tribody
