/** Zones: areas of the cloud that drones stay in or out of, and the check of a way against them. */
@NullMarked
package org.dronemap.core.zone;

import org.jspecify.annotations.NullMarked;
