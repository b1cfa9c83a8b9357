/** Missions: ordered items with altitudes that carry their reference. */
@NullMarked
package org.dronemap.core.mission;

import org.jspecify.annotations.NullMarked;
