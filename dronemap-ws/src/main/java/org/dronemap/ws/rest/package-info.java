/** The REST face: HTTP and JSON around the use cases. */
@NullMarked
package org.dronemap.ws.rest;

import org.jspecify.annotations.NullMarked;
