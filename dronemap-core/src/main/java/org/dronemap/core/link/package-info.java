/** Links to vehicles that people set up: where they are, and the keys that vehicles prove themselves with. */
@NullMarked
package org.dronemap.core.link;

import org.jspecify.annotations.NullMarked;
