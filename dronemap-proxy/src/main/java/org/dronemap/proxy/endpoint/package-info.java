/**
 * Transports: sockets that turn bytes into frames of a peer, from an endpoint URL.
 *
 * <p>Enters: a transport, and a bound on what a peer may cost.
 *
 * <p>Never: what a frame means.
 */
@NullMarked
package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.NullMarked;
