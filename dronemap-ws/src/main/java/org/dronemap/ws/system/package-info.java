/**
 * The server itself: health, parts, metrics, backups.
 *
 * <p>Enters: use cases about the server.
 *
 * <p>Never: drones and users.
 */
@NullMarked
package org.dronemap.ws.system;

import org.jspecify.annotations.NullMarked;
