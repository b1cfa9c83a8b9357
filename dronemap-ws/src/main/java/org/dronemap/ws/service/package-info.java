/** Use cases: checks, composes and maps for every face. */
@NullMarked
package org.dronemap.ws.service;

import org.jspecify.annotations.NullMarked;
