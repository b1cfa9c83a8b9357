/** Tests of the house as a whole. */
@NullMarked
package org.dronemap.ws;

import org.jspecify.annotations.NullMarked;
