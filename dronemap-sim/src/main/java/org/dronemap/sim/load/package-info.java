/**
 * Load for measuring: vehicles that send at a fixed pace, who watches the stream, who spoils the network between.
 *
 * <p>Enters: a load, an impairment or a meter.
 *
 * <p>Never: tests of behaviour.
 */
@NullMarked
package org.dronemap.sim.load;

import org.jspecify.annotations.NullMarked;
