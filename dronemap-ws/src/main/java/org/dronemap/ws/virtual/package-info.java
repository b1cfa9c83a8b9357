/**
 * Virtual drones, and the warehouse of drones that serve them.
 *
 * <p>Enters: use cases about virtual drones.
 *
 * <p>Never: how one is bound to a drone: that is core.conduct.
 */
@NullMarked
package org.dronemap.ws.virtual;

import org.jspecify.annotations.NullMarked;
