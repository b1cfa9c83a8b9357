/** Transports: sockets that turn bytes into frames of a peer, from an endpoint URL. */
@NullMarked
package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.NullMarked;
