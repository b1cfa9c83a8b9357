/** Names of places near a position, from data that ships with the product. */
@NullMarked
package org.dronemap.ws.place;

import org.jspecify.annotations.NullMarked;
