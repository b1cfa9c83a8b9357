/**
 * ROSLink: robots of the Robot Operating System on UDP and WebSocket, as drones of the cloud.
 *
 * <p>Enters: what robots need beyond their wire.
 *
 * <p>Never: MAVLink.
 */
@NullMarked
package org.dronemap.proxy.roslink;

import org.jspecify.annotations.NullMarked;
