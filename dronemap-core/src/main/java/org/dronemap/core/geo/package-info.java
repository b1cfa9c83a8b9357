/** Positions and distances on WGS-84. */
@NullMarked
package org.dronemap.core.geo;

import org.jspecify.annotations.NullMarked;
