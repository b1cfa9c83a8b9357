/**
 * Zones of the cloud that drones stay in or out of, and their file formats.
 *
 * <p>Enters: use cases about zones.
 *
 * <p>Never: fences on board.
 */
@NullMarked
package org.dronemap.ws.zone;

import org.jspecify.annotations.NullMarked;
