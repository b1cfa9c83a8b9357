/** Whose people, drones, missions and zones they are. */
@NullMarked
package org.dronemap.core.organisation;

import org.jspecify.annotations.NullMarked;
