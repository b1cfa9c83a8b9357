/** Drones that come home, or down, together: what is planned, and what is done. */
@NullMarked
package org.dronemap.cognitive.operation.recovery;

import org.jspecify.annotations.NullMarked;
