/** A multicopter that answers and flies as ArduCopter 4.5 does. */
@NullMarked
package org.dronemap.sim.personality.arducopter;

import org.jspecify.annotations.NullMarked;
