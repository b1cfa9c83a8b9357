/** The WebSocket face: live states out, commands in. */
@NullMarked
package org.dronemap.ws.stream;

import org.jspecify.annotations.NullMarked;
