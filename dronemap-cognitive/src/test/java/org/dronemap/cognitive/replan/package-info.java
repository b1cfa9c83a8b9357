@NullMarked
package org.dronemap.cognitive.replan;

import org.jspecify.annotations.NullMarked;
