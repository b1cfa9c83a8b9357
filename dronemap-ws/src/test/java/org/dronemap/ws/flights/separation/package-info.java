/**
 * Operations of several people through each other's ways, on purpose: flights that show whether all drones are kept
 * apart.
 */
@NullMarked
package org.dronemap.ws.flights.separation;

import org.jspecify.annotations.NullMarked;
