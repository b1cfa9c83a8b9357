/** Flights in the laboratory: what a whole server does with vehicles, in stepped time. */
@NullMarked
package org.dronemap.ws.flights;

import org.jspecify.annotations.NullMarked;
