/** State machines of MAVLink exchanges: a frame or a tick with its time in, messages and a result out; no sockets. */
@NullMarked
package org.dronemap.proxy.mavlink.procedure;

import org.jspecify.annotations.NullMarked;
