/** What brings a vehicle to safety that nobody looks after. Pure rules; {@code cloud} carries them out. */
@NullMarked
package org.dronemap.core.safety;

import org.jspecify.annotations.NullMarked;
