/** Tests of the sign-in from within. */
@NullMarked
package org.dronemap.ws.security;

import org.jspecify.annotations.NullMarked;
