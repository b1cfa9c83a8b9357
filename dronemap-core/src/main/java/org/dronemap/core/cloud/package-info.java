/** The cloud manager: the registry of drones, the watchdog and the one gate for commands. */
@NullMarked
package org.dronemap.core.cloud;

import org.jspecify.annotations.NullMarked;
