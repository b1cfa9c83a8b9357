/**
 * Plans for several drones: asking for one, following the search, flying it; tours of one drone.
 *
 * <p>Enters: what makes a problem of a request, or missions of a plan.
 *
 * <p>Never: the search itself: that is cognitive.
 */
@NullMarked
package org.dronemap.ws.plan;

import org.jspecify.annotations.NullMarked;
