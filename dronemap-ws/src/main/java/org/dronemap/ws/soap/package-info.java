/** The SOAP face: the controller service around the use cases. */
@NullMarked
package org.dronemap.ws.soap;

import org.jspecify.annotations.NullMarked;
