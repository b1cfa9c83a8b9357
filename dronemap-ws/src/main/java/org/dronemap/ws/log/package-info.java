/**
 * Logs on board of a vehicle, and fetching them.
 *
 * <p>Enters: use cases about these files.
 *
 * <p>Never: recordings made by the server.
 */
@NullMarked
package org.dronemap.ws.log;

import org.jspecify.annotations.NullMarked;
