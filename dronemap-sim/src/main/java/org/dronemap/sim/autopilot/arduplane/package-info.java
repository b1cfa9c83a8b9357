/**
 * An aeroplane, with or without lift motors, that answers and flies as ArduPlane 4.5 does.
 *
 * <p>Enters: what ArduPlane does, as recorded from a real one.
 *
 * <p>Never: what another autopilot does.
 */
@NullMarked
package org.dronemap.sim.autopilot.arduplane;

import org.jspecify.annotations.NullMarked;
