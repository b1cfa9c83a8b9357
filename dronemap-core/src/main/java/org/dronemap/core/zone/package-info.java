/**
 * Zones: areas of the cloud that drones stay in or out of, and the check of a way against them.
 *
 * <p>Enters: a check, or a kind of area.
 *
 * <p>Never: vehicles' own fences.
 */
@NullMarked
package org.dronemap.core.zone;

import org.jspecify.annotations.NullMarked;
