package org.dronemap.ws.wiring;

import org.apache.cxf.Bus;
import org.apache.cxf.bus.extension.ExtensionManagerBus;
import org.apache.cxf.jaxws.EndpointImpl;
import org.apache.cxf.transport.servlet.CXFNonSpringServlet;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.service.Budgets;
import org.dronemap.ws.service.CommandService;
import org.dronemap.ws.service.ControlService;
import org.dronemap.ws.service.DroneService;
import org.dronemap.ws.service.FlightService;
import org.dronemap.ws.service.FollowService;
import org.dronemap.ws.service.ParameterService;
import org.dronemap.ws.service.PlanService;
import org.dronemap.ws.service.RobotKeyService;
import org.dronemap.ws.service.RunService;
import org.dronemap.ws.service.VirtualDroneService;
import org.dronemap.ws.soap.ControllerService;
import org.dronemap.ws.soap.FollowerService;
import org.dronemap.ws.soap.KnownServices;
import org.dronemap.ws.soap.SoapActions;
import org.dronemap.ws.soap.SoapCaller;
import org.dronemap.ws.soap.SoapEndpoint;
import org.dronemap.ws.soap.SoapFlights;
import org.dronemap.ws.soap.SoapMissions;
import org.dronemap.ws.soap.SoapPlans;
import org.dronemap.ws.soap.SoapRobotKeys;
import org.dronemap.ws.soap.SoapRuns;
import org.dronemap.ws.soap.SoapVirtualDrones;
import org.springframework.boot.web.servlet.FilterRegistrationBean;
import org.springframework.boot.web.servlet.ServletRegistrationBean;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Constructs the SOAP face. */
@Configuration(proxyBeanMethods = false)
public class SoapConfiguration {

    @Bean(destroyMethod = "shutdown")
    Bus soapBus() {
        return new ExtensionManagerBus();
    }

    @Bean
    SoapCaller soapCaller(Authentication authentication, Budgets budgets) {
        return new SoapCaller(authentication, budgets);
    }

    @Bean
    ControllerService controllerService(
            SoapCaller caller,
            DroneService drones,
            CommandService commands,
            ControlService controls,
            ParameterService parameters,
            SoapMissions missions) {
        return new ControllerService(caller, drones, new SoapActions(caller, commands), controls, parameters, missions);
    }

    @Bean
    SoapMissions soapMissions(
            SoapCaller caller,
            PlanService plans,
            RunService runs,
            VirtualDroneService virtuals,
            SoapFlights flights,
            SoapRobotKeys robotKeys) {
        return new SoapMissions(
                new SoapPlans(caller, plans),
                new SoapRuns(caller, runs),
                new SoapVirtualDrones(caller, virtuals),
                flights,
                robotKeys);
    }

    @Bean
    SoapFlights soapFlights(SoapCaller caller, FlightService flights) {
        return new SoapFlights(caller, flights);
    }

    @Bean
    SoapRobotKeys soapRobotKeys(SoapCaller caller, RobotKeyService keys) {
        return new SoapRobotKeys(caller, keys);
    }

    @Bean(destroyMethod = "stop")
    EndpointImpl soapEndpoint(Bus soapBus, ControllerService controllerService) {
        return SoapEndpoint.publish(soapBus, controllerService);
    }

    @Bean(destroyMethod = "stop")
    EndpointImpl followerEndpoint(Bus soapBus, SoapCaller caller, FollowService follows) {
        return SoapEndpoint.publish(soapBus, new FollowerService(caller, follows));
    }

    @Bean
    FilterRegistrationBean<KnownServices> knownServices(ProblemWriter problems) {
        FilterRegistrationBean<KnownServices> registration = new FilterRegistrationBean<>(new KnownServices(problems));
        registration.addUrlPatterns("/services", "/services/*");
        return registration;
    }

    @Bean
    ServletRegistrationBean<CXFNonSpringServlet> soapServlet(Bus soapBus) {
        CXFNonSpringServlet servlet = new CXFNonSpringServlet();
        servlet.setBus(soapBus);
        ServletRegistrationBean<CXFNonSpringServlet> registration =
                new ServletRegistrationBean<>(servlet, "/services/*");
        registration.setName("soap");
        registration.addInitParameter("hide-service-list-page", "true");
        return registration;
    }
}
