/**
 * Ways in for vehicles: endpoints, link security, keys of vehicles.
 *
 * <p>Enters: use cases about links, and the ports that the proxy implements.
 *
 * <p>Never: bytes and sockets.
 */
@NullMarked
package org.dronemap.ws.link;

import org.jspecify.annotations.NullMarked;
