/** A multicopter that answers and flies as PX4 1.14 does. */
@NullMarked
package org.dronemap.sim.personality.px4;

import org.jspecify.annotations.NullMarked;
