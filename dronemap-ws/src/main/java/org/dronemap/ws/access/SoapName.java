package org.dronemap.ws.access;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Names a REST operation differently in SOAP than by its operationId, as the original Dronemap Planner named it. */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface SoapName {
    String value() default "";

    /** Where a body has alternatives, each is an operation named as the alternative; {@code alternative=name} for other names. */
    String[] alternatives() default {};
}
