/**
 * Vehicles that wait to be let in.
 *
 * <p>Enters: use cases about who waits.
 *
 * <p>Never: how a vehicle is recognised: that is core.cloud.
 */
@NullMarked
package org.dronemap.ws.enrol;

import org.jspecify.annotations.NullMarked;
