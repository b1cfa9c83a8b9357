/** Parts of the use cases by themselves. */
@NullMarked
package org.dronemap.ws.service;

import org.jspecify.annotations.NullMarked;
