/**
 * State machines of MAVLink exchanges: a frame or a tick with its time in, messages and a result out; no sockets.
 *
 * <p>Enters: an exchange that takes several messages.
 *
 * <p>Never: sockets, threads and clocks.
 */
@NullMarked
package org.dronemap.proxy.mavlink.procedure;

import org.jspecify.annotations.NullMarked;
