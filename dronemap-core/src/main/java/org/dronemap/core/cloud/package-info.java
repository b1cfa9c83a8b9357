/**
 * The cloud manager: the registry of drones, the watchdog and the one gate for commands.
 *
 * <p>Enters: what happens to one drone on its lane, or at the gate.
 *
 * <p>Never: protocols, sockets and databases.
 */
@NullMarked
package org.dronemap.core.cloud;

import org.jspecify.annotations.NullMarked;
