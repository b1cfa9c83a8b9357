/**
 * A multicopter that answers and flies as PX4 1.14 does.
 *
 * <p>Enters: what PX4 does, as recorded from a real one.
 *
 * <p>Never: what another autopilot does.
 */
@NullMarked
package org.dronemap.sim.autopilot.px4;

import org.jspecify.annotations.NullMarked;
