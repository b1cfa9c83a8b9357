package org.dronemap.ws.http;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Declares HTTP statuses of a REST operation that its signature does not imply, for the OpenAPI description. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface ResponseStatuses {
    /** Of success, where it decides that itself. */
    int[] value() default {};

    /** Of refusals, beside what follows from who may call it, what it takes and whether it changes anything. */
    int[] refuses() default {};

    /** Of refusals that follow from these, and that it has no reason for. */
    int[] never() default {};
}
