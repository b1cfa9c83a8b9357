/**
 * Fences and rally points on board of a vehicle.
 *
 * <p>Enters: what a vehicle itself keeps of areas.
 *
 * <p>Never: zones of the cloud.
 */
@NullMarked
package org.dronemap.ws.fence;

import org.jspecify.annotations.NullMarked;
