/**
 * What brings a vehicle to safety that nobody looks after. Pure rules; {@code cloud} carries them out.
 *
 * <p>Enters: a rule, with its time or its height.
 *
 * <p>Never: clocks and commands.
 */
@NullMarked
package org.dronemap.core.safety;

import org.jspecify.annotations.NullMarked;
