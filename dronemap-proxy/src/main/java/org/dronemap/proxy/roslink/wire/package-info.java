/**
 * ROSLink on the wire: JSON in, messages of robots out; orders in, JSON out. Pure, without time or sockets.
 *
 * <p>Enters: a message of the protocol.
 *
 * <p>Never: time and sockets.
 */
@NullMarked
package org.dronemap.proxy.roslink.wire;

import org.jspecify.annotations.NullMarked;
