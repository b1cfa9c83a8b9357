/** ROSLink: robots of the Robot Operating System on UDP and WebSocket, as drones of the cloud. */
@NullMarked
package org.dronemap.proxy.roslink;

import org.jspecify.annotations.NullMarked;
