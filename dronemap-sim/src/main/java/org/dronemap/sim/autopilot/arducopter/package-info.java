/**
 * A multicopter that answers and flies as ArduCopter 4.5 does.
 *
 * <p>Enters: what ArduCopter does, as recorded from a real one.
 *
 * <p>Never: what another autopilot does.
 */
@NullMarked
package org.dronemap.sim.autopilot.arducopter;

import org.jspecify.annotations.NullMarked;
