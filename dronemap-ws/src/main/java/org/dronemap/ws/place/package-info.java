/**
 * Names of places near a position, from data that ships with the product.
 *
 * <p>Enters: names that ship with the product.
 *
 * <p>Never: a service of others.
 */
@NullMarked
package org.dronemap.ws.place;

import org.jspecify.annotations.NullMarked;
