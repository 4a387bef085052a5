// Makes nothing here.
#pragma once
class FEM_ObjectBroker {};
